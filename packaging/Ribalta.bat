@echo off
rem Double-click: opens the window of Ribalta. The first time it installs what it needs, some minutes.
cd /d "%~dp0.."
for %%v in (3.14 3.13 3.12 3.11) do (py -%%v -c "" >nul 2>nul && (py -%%v run.py %* & goto end))
where py >nul 2>nul && (py run.py %* & goto end)
where python >nul 2>nul && (python run.py %* & goto end)
echo Python 3.11 to 3.14 is missing: install it from python.org, ticking "Add python.exe to PATH".
:end
if errorlevel 1 pause
