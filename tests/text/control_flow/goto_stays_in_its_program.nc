O1 (CTL-2: a label of the caller is not found)
M98 P2
N50 M30
O2
GOTO 50 (expect alarm PS0128)
M99
