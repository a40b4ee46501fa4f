# Picture tests in addition to the example of docs/compare.md.
set(here "${CMAKE_CURRENT_SOURCE_DIR}")
set(camera --size 80x60 --camera 0,0,5,0,0,0,0,1,0)

# The mesh has moved by 0.25 since the baseline.
relievo_add_picture_test(NAME moved
  COMMAND Relievo::relievo render "${here}/moved/bunny.off" ${camera} --baseline moved.exr
  BASELINE baselines/moved.exr)
# Pictures without layers, three levels lighter.
foreach (levels IN ITEMS 2 3)
  relievo_add_picture_test(NAME levels/${levels}
    COMMAND Relievo::relievo render "${here}/bunny.off" ${camera} --background "#030303" --png levels.png
    BASELINE baselines/black.png
    OUTPUT levels.png
    LIMITS --levels ${levels})
endforeach ()
relievo_add_picture_test(NAME missing
  COMMAND Relievo::relievo render "${here}/bunny.off" ${camera} --baseline missing.exr
  BASELINE baselines/none.exr)
relievo_add_picture_test(NAME broken
  COMMAND Relievo::relievo render none.off --baseline broken.exr
  BASELINE baselines/moved.exr)
# The command prints its words and leaves an old picture unchanged.
relievo_add_picture_test(NAME old
  COMMAND "${CMAKE_COMMAND}" -E echo "some; words" -- "\\\"'"
  BASELINE baselines/moved.exr
  OUTPUT old.exr)
