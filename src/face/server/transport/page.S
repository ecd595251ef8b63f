# The packed page, as the linker sees it: kerf_page_begin to kerf_page_end.
  .section .rodata
  .global kerf_page_begin
  .global kerf_page_end
  .balign 16
kerf_page_begin:
  .incbin KERF_PAGE_FILE
kerf_page_end:
  .byte 0
  .section .note.GNU-stack,"",%progbits
