/* The words of the hull table as they are in its file, in flash. QUICKSTRIP_HULL_TABLE: the file's name. */
        .section .rodata.hull_table, "a"
        .balign 4
        .global quickstrip_hull_table
quickstrip_hull_table:
        .incbin QUICKSTRIP_HULL_TABLE
        .global quickstrip_hull_table_end
quickstrip_hull_table_end:
        .balign 4

#if defined(__linux__)
        .section .note.GNU-stack, "", %progbits
#endif
