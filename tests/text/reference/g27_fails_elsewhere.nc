O1 (section 8.1: 5 is no reference point)
G90 G00 X2.
G27 X5. (expect alarm PS0092)
M30
