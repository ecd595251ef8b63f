O1 (TRF-3: the rotation is one of G17)
G17 G68 X0 Y0 R90.
G18 G02 X10. Z0 R5. F100 (expect alarm PS0144)
M30
