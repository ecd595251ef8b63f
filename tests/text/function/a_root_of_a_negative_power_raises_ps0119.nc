O1 (section 4.2: POW[-2,0.5] is not real)
#100=POW[-2,0.5] (expect alarm PS0119)
M30
