O1 (section 10: K3 in G91)
G90 G00 Z10.
G91 G99 G81 X10. Z-12. R-8. K3 F100
G80
M30
(finally moves: rapid Z10; rapid X10 Z10; rapid X10 Z2; line X10 Z-10 F100; rapid X10 Z2; rapid X20 Z2; line X20 Z-10; rapid X20 Z2; rapid X30 Z2; line X30 Z-10; rapid X30 Z2)
