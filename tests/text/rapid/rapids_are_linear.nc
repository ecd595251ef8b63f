O1 (section 8.1: G00, LRP)
G00 X10. Y1. (expect moves: rapid X10 Y1 linear)
G99 G81 X20. Z-5. R2. F500 (expect moves: rapid X20 linear; rapid Z2 linear; line Z-5; rapid Z2 linear)
M30
