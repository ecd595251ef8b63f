O1 (section 4.2: domain 0 to 99999999)
#100=BCD[100000000] (expect alarm PS0119)
M30
