O1 (section 13: words beside a statement, and a division by 0)
M08 #1=2/0 (expect alarm PS0127)
M30
