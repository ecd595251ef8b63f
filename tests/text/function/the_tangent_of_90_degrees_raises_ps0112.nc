O1 (section 4.2: the cosine is 0)
#100=TAN[90] (expect alarm PS0112)
M30
