# cmake -DMODULE=FILE -DFILE=OUT -P write_module_hash.cmake: the module's checksum as a source file of the program, touched only when it
# changes. A program with another module is another program.
file(SHA1 ${MODULE} hash)
file(CONFIGURE OUTPUT ${FILE} CONTENT "extern const char *const tissue_module_hash;\nconst char *const tissue_module_hash = \"${hash}\";\n")
