O1 (section 10: like G80)
G90 G00 Z10.
G99 G81 X1. Z-5. R2. F100
G00 X5. (expect moves: rapid X5 Z2)
#100=#4009 (expect #100=80)
X6. (expect moves: rapid X6 Z2)
M30
