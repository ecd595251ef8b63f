O1 (PS0203: M29 stands before the cycle)
S100 M03
G84 X1. Z-5. R2. F100
M29 S200 (expect alarm PS0203 at M29)
M30
