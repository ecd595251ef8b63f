O1 (EXP-7: nothing behind the plus)
#100=2+ (expect alarm PS0114)
M30
