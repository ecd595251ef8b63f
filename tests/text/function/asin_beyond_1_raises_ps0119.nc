O1 (section 4.2: domain -1 to 1)
#100=ASIN[1.5] (expect alarm PS0119)
M30
