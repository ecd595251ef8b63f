O1 (CTL-14, P38)
END1 (expect alarm PS1124)
M30
