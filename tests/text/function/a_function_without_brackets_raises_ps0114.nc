O1 (section 4.2: SIN30)
#100=SIN30 (expect alarm PS0114)
M30
