O1 (PS0092: machine 5 is no reference point)
G90 G27 X5. (expect alarm PS0092)
M30
