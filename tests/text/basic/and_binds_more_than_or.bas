print 1 or 0 and 0; (1 or 0) and 0; 2 and 3; 0 or 0.5; 0 and 1
' (finally prints 1 0 1 1 0)
