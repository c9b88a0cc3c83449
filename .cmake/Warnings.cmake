# One INTERFACE target carries the house's warnings (style: targets, not flags).
add_library(quickstrip_warnings INTERFACE)
target_compile_options(quickstrip_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wdouble-promotion
  $<$<COMPILE_LANGUAGE:CXX>:-Wold-style-cast>
  $<IF:$<BOOL:${QUICKSTRIP_FUZZ}>,-w,-Werror>  # the fuzz build is clang's, whose warnings are clang-tidy's matter
  -ffp-contract=off)  # same bits on every run of one build

# What reads a command line: CLI11's templates cost 37 s a file to optimise with sanitizers, 10 s without
# optimisation, and there is no loop of ours that would be worth it.
add_library(quickstrip_quick_to_compile INTERFACE)
target_compile_options(quickstrip_quick_to_compile INTERFACE $<$<CONFIG:RelWithDebInfo>:-O0> $<$<CONFIG:Release>:-O1>)
