O1 (CTL-15: DO2 would end outside of DO1)
DO1
DO2 (expect alarm PS0124)
END1
END2
M30
