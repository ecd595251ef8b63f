O1 (CTL-14)
END1 (expect alarm PS1124)
M30
