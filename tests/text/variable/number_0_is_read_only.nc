O1 (section 2: #0 is vacant for ever)
#0=5 (expect alarm PS0116 at #0)
M30
