O1 (PS0051: the block behind the corner does not move)
G01 X10. F100 ,R2. (expect alarm PS0051)
M08
Y10.
M30
