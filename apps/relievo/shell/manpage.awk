# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Writes relievo.1 from the output of `relievo --help`; -v version=N.
#   the first line      name - description
#   lines by 2, before any other text: ways to call it
#   lines by 0          text; "Examples" alone begins the lines to be shown as they are
#   lines by 2          an option or word, two blanks, its meaning, which continues in lines by 26

function quoted(text) {
  gsub(/\\/, "\\e", text)
  gsub(/-/, "\\-", text)
  gsub(/\[,/, "\\:[,", text) # where a long option may be broken
  if (text ~ /^[.']/) text = "\\&" text
  return text
}
function say(text) { print quoted(text) }
# The name of a command begins the part that is about it.
function heading(word) {
  if (word in commands) print ".SH RELIEVO " toupper(word)
}

NR == 1 {
  print ".TH RELIEVO 1 \"\" \"relievo " version "\" \"User Commands\"\n.ad l\n.nh"
  print ".SH NAME"
  say($0)
  print ".SH SYNOPSIS"
  part = "synopsis"
  next
}
part == "synopsis" && /^  / {
  commands[$2] = 1
  print ".B " quoted(substr($0, 3))
  print ".br"
  next
}
/^$/ { inside = 0; next }
/^Examples$/ {
  print ".SH EXAMPLES\n.nf"
  part = "examples"
  next
}
part == "examples" { say($0); next }
/^[^ ]/ {
  if (part == "synopsis") part = "text"
  if (!inside) {
    if ($0 ~ /^Options are/) print ".SH NOTES"
    else heading($1)
    print ".PP"
  }
  inside = 1
  say($0)
  next
}
/^  (-|[A-Z]+  )/ {
  line = substr($0, 3)
  at = match(line, /  +/)
  print ".TP"
  print ".B " quoted(at ? substr(line, 1, RSTART - 1) : line)
  if (at) say(substr(line, RSTART + RLENGTH))
  next
}
# Tables inside the meaning of an option keep their lines.
/^ {28}/ || /^                            / {
  print ".br"
  say(substr($0, 27))
  table = 1
  next
}
{
  if (table) print ".br"
  table = 0
  sub(/^ +/, "")
  say($0)
}
