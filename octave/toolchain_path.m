## Put the toolchain's folders on the load path: `source octave/toolchain_path.m` from anywhere.
warning ("off", "Octave:shadowed-function");  # the scene `cylinder' has the name of a function of Octave
addpath (genpath (fileparts (mfilename ("fullpath"))));
addpath (fullfile (fileparts (fileparts (mfilename ("fullpath"))), "generated"));
