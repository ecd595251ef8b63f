O1 (CALL-3: there is no O99)
G90 G00 X1. (expect moves: rapid X1)
M98 P99 (expect alarm PS0076 at P99)
M30
