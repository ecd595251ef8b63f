O1 (PS1196: the drilling axis would change)
G17 G81 X1. Z-5. R2. F100
G18 X2. (expect alarm PS1196)
M30
