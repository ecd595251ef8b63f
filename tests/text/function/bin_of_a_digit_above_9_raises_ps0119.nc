O1 (section 4.2: 26 is hexadecimal 1A)
#100=BIN[26] (expect alarm PS0119)
M30
