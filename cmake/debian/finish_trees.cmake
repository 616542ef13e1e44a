# SPDX-License-Identifier: Apache-2.0
# CPack runs this between installing the components and packing them. Input: the tree of each component below
# CPACK_TEMPORARY_DIRECTORY. Adds the documents that Debian's policy asks of each package, and compresses the man page.
function(compress file)
  execute_process(COMMAND gzip -9n --force ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  set(tree ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr)
  set(documents ${tree}/share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  file(COPY ${CPACK_MERISTEM_DOCUMENTS} DESTINATION ${documents}
       FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ
       DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  compress(${documents}/changelog.Debian)
  compress(${documents}/changelog)
  file(GLOB pages ${tree}/share/man/man1/*.1)
  foreach(page IN LISTS pages)
    compress(${page})
  endforeach()
  # Debian's zsh looks for functions of packages here.
  if(EXISTS ${tree}/share/zsh/site-functions)
    file(RENAME ${tree}/share/zsh/site-functions ${tree}/share/zsh/vendor-completions)
  endif()
endforeach()
