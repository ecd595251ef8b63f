O1 (CTL-13: DO and END stand in the same program)
M98 P2
M30
END1
O2
DO1 (expect alarm PS0124)
M99
