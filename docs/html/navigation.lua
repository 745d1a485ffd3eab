-- docs/index.md as the list at a page's side: sections, and the first link of each item. `-M to_docs=PATH` leads from the page
-- to docs/.
function Pandoc(index)
  local to_docs = pandoc.utils.stringify(index.meta.to_docs)
  local blocks = pandoc.List()
  for _, block in ipairs(index.blocks) do
    if block.t == "Header" and block.level == 1 then
      blocks:insert(pandoc.Para(pandoc.Link("Arenite", to_docs .. "index.html")))
    elseif block.t == "Header" then
      blocks:insert(pandoc.Header(2, block.content))
    elseif block.t == "BulletList" then
      local items = pandoc.List()
      for _, item in ipairs(block.content) do
        local first
        pandoc.walk_block(pandoc.Div(item), { Link = function(link) first = first or link end })
        if first then
          items:insert({ pandoc.Plain(pandoc.Link(first.content, to_docs .. first.target:gsub("%.md$", ".html"))) })
        end
      end
      blocks:insert(pandoc.BulletList(items))
    end
  end
  return pandoc.Pandoc(blocks)
end
