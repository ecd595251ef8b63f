O1 (section 9: there are 400 offsets)
G41 D401 G01 X1. F100 (expect alarm PS0030 at D401)
Y5.
M30
