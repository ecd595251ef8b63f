O1 (G16: the example of section 8.5)
G90 G00 Z10.
G17 G90 G16
G81 X100. Y30. Z-20. R5. F200 (expect moves: rapid X86.6025 Y50; rapid Z5; line Z-20 F200; rapid Z10)
G15 G80
M30
