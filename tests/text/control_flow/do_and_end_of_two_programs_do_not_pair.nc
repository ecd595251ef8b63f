O1 (CTL-19: the END of the subprogram has no DO)
DO1
M98 P2
END1
M30
O2
END1 (expect alarm PS1124)
M99
