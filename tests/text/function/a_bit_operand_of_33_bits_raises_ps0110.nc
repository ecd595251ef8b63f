O1 (section 4.2: 2 to the 33rd)
#100=8589934592 AND 1 (expect alarm PS0110)
M30
