O1 (VAR-4: the longest literal)
#100=123456789012
#101=#100-123456789000 (expect #101=12)
M30
