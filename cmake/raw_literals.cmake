# The text file PATH as raw literals of C++ in the variable OUT, 8000 characters each, which every compiler takes, and
# compiles much faster than a list of bytes.
function(raw_literals path out)
  file(READ ${path} text)
  string(LENGTH "${text}" length)
  set(literals "")
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${text}" ${at} 8000 piece)
    string(APPEND literals "R\"text~(${piece})text~\"\n")
    math(EXPR at "${at} + 8000")
  endwhile()
  set(${out} "${literals}" PARENT_SCOPE)
endfunction()
