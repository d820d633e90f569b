; Inno Setup 6: the installer of Windows, from dist\ribalta.   iscc /DVersion=0.7.0 packaging\windows\ribalta.iss
; Not compiled on the machine it was written on (Linux); .github/workflows/package.yml does it on Windows.
#ifndef Version
  #error Give the version: iscc /DVersion=...
#endif

[Setup]
AppId={{6B1E4B0C-5D0B-4B63-9C3B-9C1D0B7C4A51}
AppName=Ribalta
AppVersion={#Version}
AppPublisher=Ribalta
DefaultDirName={autopf}\Ribalta
DefaultGroupName=Ribalta
DisableProgramGroupPage=yes
LicenseFile=..\..\LICENSE
OutputDir=..\..\dist
OutputBaseFilename=ribalta-{#Version}-windows-x86_64
SetupIconFile=..\..\build\parts\ribalta.ico
UninstallDisplayIcon={app}\ribaltaw.exe
Compression=lzma2/ultra64
SolidCompression=yes
ArchitecturesAllowed=x64compatible
ArchitecturesInstallIn64BitMode=x64compatible
; for all users or, without administrator rights, for one
PrivilegesRequired=lowest
PrivilegesRequiredOverridesAllowed=dialog
ChangesAssociations=yes
MinVersion=10.0

[Languages]
Name: "en"; MessagesFile: "compiler:Default.isl"
Name: "it"; MessagesFile: "compiler:Languages\Italian.isl"

[CustomMessages]
en.Associate=Open case files (.ribalta) with Ribalta
it.Associate=Apri con Ribalta i file dei casi (.ribalta)
en.CaseFile=Ribalta case
it.CaseFile=Caso di Ribalta

[Tasks]
Name: "associate"; Description: "{cm:Associate}"
Name: "desktopicon"; Description: "{cm:CreateDesktopIcon}"; Flags: unchecked

[InstallDelete]
; an older version's modules must not stay among the new ones; settings and caches are the user's and elsewhere
Type: filesandordirs; Name: "{app}\_internal"
Type: filesandordirs; Name: "{app}\licences"

[Files]
Source: "..\..\dist\ribalta\*"; DestDir: "{app}"; Flags: recursesubdirs ignoreversion

[Icons]
Name: "{autoprograms}\Ribalta"; Filename: "{app}\ribaltaw.exe"
Name: "{autodesktop}\Ribalta"; Filename: "{app}\ribaltaw.exe"; Tasks: desktopicon

[Registry]
Root: HKA; Subkey: "Software\Classes\.ribalta"; ValueType: string; ValueData: "Ribalta.Case"; Flags: uninsdeletevalue; Tasks: associate
Root: HKA; Subkey: "Software\Classes\Ribalta.Case"; ValueType: string; ValueData: "{cm:CaseFile}"; Flags: uninsdeletekey; Tasks: associate
Root: HKA; Subkey: "Software\Classes\Ribalta.Case\DefaultIcon"; ValueType: string; ValueData: "{app}\ribaltaw.exe,0"; Tasks: associate
Root: HKA; Subkey: "Software\Classes\Ribalta.Case\shell\open\command"; ValueType: string; ValueData: """{app}\ribaltaw.exe"" ""%1"""; Tasks: associate

[Run]
Filename: "{app}\ribaltaw.exe"; Description: "{cm:LaunchProgram,Ribalta}"; Flags: nowait postinstall skipifsilent
