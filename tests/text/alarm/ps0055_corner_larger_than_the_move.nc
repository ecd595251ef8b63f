O1 (PS0055: the first move is shorter than the radius)
G01 X1. F100 ,R2. (expect alarm PS0055)
Y10.
M30
