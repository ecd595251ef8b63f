O1(a G code before the call leaves the name of the program alone)
G90 G65 <NOWHERE> A1. (expect alarm PS0310)
M30
