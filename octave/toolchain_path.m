## Put the toolchain's folders on the load path: `source octave/toolchain_path.m` from anywhere.  Scenes stay off it:
## their names are their own (see `load_scene').
addpath (genpath (fileparts (mfilename ("fullpath")), "scenes"));
addpath (fullfile (fileparts (fileparts (mfilename ("fullpath"))), "generated"));
