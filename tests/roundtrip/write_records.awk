# Join the shapes (first file: record, shape) and the bodies (second file: one a line) to records of the translator.

FNR == NR {
  results[$1] = results[$1] "result: r" ++count[$1] " | " $2 " | 1 | result\n"
  next
}

{
  name = "batch_" FNR
  file = folder "/" name ".mx"
  printf "maxima2octave: 1\nfunction: %s\n", name >file
  while ((getline line <head) > 0)
    print line >file
  close(head)
  printf "%sbody: %s\nend: %s\n", results[FNR], $0, name >file
  close(file)
}
