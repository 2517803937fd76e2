# find_package(provis) defines provis::provis. The libraries are static, so whoever links them links
# what they use, too.
include(CMakeFindDependencyMacro)
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})  # for FindMPFI.cmake
find_dependency(MPFI)
find_dependency(TBB)
find_dependency(draco)
find_dependency(fmt)
find_dependency(meshoptimizer)
find_dependency(OpenSSL COMPONENTS Crypto)
find_dependency(PNG)
list(REMOVE_ITEM CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
include(${CMAKE_CURRENT_LIST_DIR}/provisTargets.cmake)
