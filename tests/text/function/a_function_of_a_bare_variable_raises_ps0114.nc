O1 (section 4.2: SIN#1)
#1=30
#100=SIN#1 (expect alarm PS0114)
M30
