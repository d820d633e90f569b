@echo off
rem Double-click: opens the window of Ribalta. The first time it installs what it needs, some minutes.
cd /d "%~dp0.."
where py >nul 2>nul && (py run.py %* & goto end)
where python >nul 2>nul && (python run.py %* & goto end)
echo Python 3.11 or newer is missing: install it from python.org, ticking "Add python.exe to PATH".
:end
if errorlevel 1 pause
