O9200 (section 12.2 as printed: without G80 the next move drills)
G90 G00 Z10.
G99 G81 X0. Y0. Z-20. R-15. F1000 K0
G65 P9401 X40. Y-20.
X0 (expect moves: rapid X0 Y-20 Z-15; line Z-20; rapid Z-15)
M02
O9401
X#24 Y#25
M99
