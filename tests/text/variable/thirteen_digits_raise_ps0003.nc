O1 (VAR-4: a literal has at most 12 digits)
#100=1234567890123 (expect alarm PS0003)
M30
