// The bytes of the fonts, from the files that CMake found, so that the window looks the same wherever it runs.
  .section .rodata
  .balign 16
  .globl penumbra_text_font, penumbra_text_font_end, penumbra_heading_font, penumbra_heading_font_end
  .globl penumbra_mono_font, penumbra_mono_font_end
penumbra_text_font:
  .incbin PENUMBRA_TEXT_FONT
penumbra_text_font_end:
penumbra_heading_font:
  .incbin PENUMBRA_HEADING_FONT
penumbra_heading_font_end:
penumbra_mono_font:
  .incbin PENUMBRA_MONO_FONT
penumbra_mono_font_end:
  .section .note.GNU-stack,"",@progbits
