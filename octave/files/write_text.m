## -*- texinfo -*-
## @deftypefn {} {} write_text (@var{file}, @var{text})
## Write a text file; a folder that is missing or a full disk is an error that names the file.
## @end deftypefn

function write_text (file, text)
  [id, message] = fopen (file, "w");
  if (id < 0)
    scene_error ("%s cannot be written: %s", file, message);
  endif
  written = fwrite (id, text);
  ## what a full disk has not taken shows in the size alone: a short text waits in a buffer until the file is closed
  if (fclose (id) != 0 || written != numel (text) || stat (file).size != numel (text))
    scene_error ("%s cannot be written whole: is the disk full?", file);
  endif
endfunction

%!error <cannot be written> write_text (fullfile (tempname (), "nowhere"), "text")
%!error <cannot be written whole: is the disk full> write_text ("/dev/full", repmat ("text", 1, 1e5))
%!error <cannot be written whole: is the disk full> write_text ("/dev/full", "short")
