O0 (LEX-3: there is no program 0) (expect alarm PS0074)
#100=1
M30
