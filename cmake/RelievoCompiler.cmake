# The compiler cache, warnings and sanitizers, as options of the whole build.

find_program(RELIEVO_CCACHE ccache DOC "Compiler cache; empty: none")
mark_as_advanced(RELIEVO_CCACHE)
if (RELIEVO_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  # Relative to the source, so that copies of the tree share cached objects.
  set(CMAKE_CXX_COMPILER_LAUNCHER
    "${CMAKE_COMMAND}" -E env "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}"
    "CCACHE_SLOPPINESS=pch_defines,time_macros" # otherwise it does not cache objects that use precompiled headers
    "${RELIEVO_CCACHE}")
endif ()
# Sources that are compiled several at once are included by absolute paths, which __FILE__ would contain:
# then a copy of the tree finds none of them in the cache.
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag("-fmacro-prefix-map=/a/=" RELIEVO_HAS_MACRO_PREFIX_MAP) # GCC 8, Clang 10
if (RELIEVO_HAS_MACRO_PREFIX_MAP)
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:-fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=>")
endif ()

# VTK includes a generated header by an absolute path in a macro, which the cache cannot make relative.
function (relievo_relative_autoinit)
  foreach (target IN LISTS ARGN)
    get_target_property(aliased "${target}" ALIASED_TARGET)
    if (aliased)
      set(target "${aliased}")
    endif ()
    get_target_property(macros "${target}" COMPILE_DEFINITIONS)
    if (macros)
      string(REPLACE "\"${CMAKE_BINARY_DIR}/CMakeFiles/" "\"" macros "${macros}")
      set_target_properties("${target}" PROPERTIES COMPILE_DEFINITIONS "${macros}")
      target_include_directories("${target}" PRIVATE "${CMAKE_BINARY_DIR}/CMakeFiles")
    endif ()
  endforeach ()
endfunction ()

# Layers by rays are the same bytes on every processor: no fused products and sums in these modules.
check_cxx_compiler_flag(-ffp-contract=off RELIEVO_HAS_FP_CONTRACT)
function (relievo_round_each_operation module)
  if (RELIEVO_HAS_FP_CONTRACT)
    vtk_module_compile_options("${module}" PRIVATE -ffp-contract=off)
  endif ()
endfunction ()

# The environment in which an uninstrumented interpreter can load instrumented libraries. Python
# does not free its own memory: leaks are checked by the C++ tests.
set(relievo_sanitizer_environment)
if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:-Wall;-Wextra;-Wshadow;-Wnon-virtual-dtor>")
  if (RELIEVO_WARNINGS_AS_ERRORS)
    add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:-Werror>")
  endif ()
  if (RELIEVO_SANITIZE)
    add_compile_options(-fsanitize=address,undefined -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address,undefined)
    set(relievo_preload)
    # Also the C++ library: the sanitizer looks up intercepted functions in it at start.
    foreach (name IN ITEMS libasan.so libstdc++.so)
      execute_process(COMMAND "${CMAKE_CXX_COMPILER}" "-print-file-name=${name}"
        OUTPUT_VARIABLE path OUTPUT_STRIP_TRAILING_WHITESPACE)
      list(APPEND relievo_preload "${path}")
    endforeach ()
    list(JOIN relievo_preload ":" relievo_preload)
    set(relievo_sanitizer_environment "LD_PRELOAD=${relievo_preload}" "ASAN_OPTIONS=detect_leaks=0")
  endif ()
endif ()
