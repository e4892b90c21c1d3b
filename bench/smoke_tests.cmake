# Every scene draws, and not nothing.
foreach(scene IN ITEMS morph heavy overdraw_btf overdraw_ftb many wire)
  add_test(NAME bench/draw_${scene} COMMAND morphcl_bench_draw ${scene} --frames 1 --size 80x60)
  set_tests_properties(bench/draw_${scene} PROPERTIES PASS_REGULAR_EXPRESSION "\"covered\":[1-9]")
endforeach()
# What is timed has the reference's bits.
foreach(scene IN ITEMS morph heavy overdraw_btf overdraw_ftb many wire)
  add_test(NAME bench/parity_${scene} COMMAND morphcl_bench_parity ${scene} --size 160x90)
endforeach()
# Several samples and blended surfaces, as the part samples draws them.
foreach(scene_samples IN ITEMS morph/4 heavy/4 overdraw_btf/4 overdraw_ftb/4 many/4 morph/16 heavy/16 blended/1 blended/4)
  string(REPLACE "/" ";" parts ${scene_samples})
  list(GET parts 0 scene)
  list(GET parts 1 samples)
  add_test(NAME bench/draw_${scene}_by_${samples}
    COMMAND morphcl_bench_draw ${scene} --samples ${samples} --colors-only --frames 1 --size 80x60)
  set_tests_properties(bench/draw_${scene}_by_${samples} PROPERTIES PASS_REGULAR_EXPRESSION "\"covered\":[1-9]")
  add_test(NAME bench/parity_${scene}_by_${samples}
    COMMAND morphcl_bench_parity ${scene} --samples ${samples} --size 160x90)
endforeach()
# The peer draws them too, where its driver does.
if(TARGET morphcl_peer_llvmpipe)
  foreach(resolve IN ITEMS blit shader)
    add_test(NAME bench/llvmpipe_by_${resolve}
      COMMAND morphcl_peer_llvmpipe morph --samples 4 --resolve ${resolve} --frames 1 --size 80x60)
    set_tests_properties(bench/llvmpipe_by_${resolve} PROPERTIES SKIP_RETURN_CODE 69)
  endforeach()
endif()
foreach(scene_amount IN ITEMS heavy/10000 overdraw_ftb/3 crowd/1000 crowd_in_view/1000 rig/3 rig/40)
  string(REPLACE "/" ";" parts ${scene_amount})
  list(GET parts 0 scene)
  list(GET parts 1 amount)
  add_test(NAME bench/draw_${scene}_${amount}
    COMMAND morphcl_bench_draw ${scene} --amount ${amount} --frames 1 --size 80x60)
  set_tests_properties(bench/draw_${scene}_${amount} PROPERTIES PASS_REGULAR_EXPRESSION "\"covered\":[1-9]")
endforeach()

add_test(NAME bench/plan_savings COMMAND morphcl_bench_plan ${PROJECT_SOURCE_DIR}/demos/held_frames.toml --rounds 1 --frames 3)
set_tests_properties(bench/plan_savings PROPERTIES PASS_REGULAR_EXPRESSION "held_frames.toml,blank tiles,[0-9.]+,[0-9.]+")

# The tool draws the shot of a scene as morphcl_bench_draw draws the scene.
foreach(scene IN ITEMS morph heavy wire)
  add_test(NAME bench/shot_${scene} COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/shot_smoke_test.sh $<TARGET_FILE:morphcl_bench_shot>
    $<TARGET_FILE:morphcl_bench_draw> $<TARGET_FILE:morphcl_bench_picture> $<TARGET_FILE:morphcl_tool> ${scene})
endforeach()

find_package(Python3 QUIET COMPONENTS Interpreter)
if(Python3_FOUND)
  add_test(NAME bench/lib COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/tests/lib_test.py)
endif()
