O1 (VAR-9: without an axis word the cycle is not executed)
G90 G00 Z10.
G99 G81 X1. Y0 Z-5. R2. F100
X#1 (expect moves: none)
G80
M30
