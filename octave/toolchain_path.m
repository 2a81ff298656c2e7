## Put the toolchain's folders on the load path: `source octave/toolchain_path.m` from anywhere.
1;
addpath (genpath (fileparts (mfilename ("fullpath"))));
addpath (fullfile (fileparts (fileparts (mfilename ("fullpath"))), "generated"));
