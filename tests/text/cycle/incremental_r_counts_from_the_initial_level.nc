O1 (section 10: and incremental Z from R)
G90 G00 Z20.
G91 G98 G81 X5. R-18. Z-6. F100 (expect moves: rapid X5 Z20; rapid Z2; line Z-4; rapid Z20)
G80
M30
