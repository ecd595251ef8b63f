O1 (section 10: the next block drills once)
G90 G00 Z10.
G91 G99 G81 X1. Z-7. R-8. K2 F100
X1. (expect moves: rapid X3; line Z-5; rapid Z2)
G80
M30
