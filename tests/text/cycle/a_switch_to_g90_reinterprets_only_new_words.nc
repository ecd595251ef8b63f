O1 (section 10: Z and R of G91 are kept as levels)
G90 G00 Z20.
G91 G99 G81 X5. R-18. Z-6. F100
G90 X7. (expect moves: rapid X7 Z2; line Z-4; rapid Z2)
G80
M30
